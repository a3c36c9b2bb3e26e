"""The page Which procedure?: plans for a sensor and a rig, and how well they would do."""
