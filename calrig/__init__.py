"""The launcher of CalRig. The program itself is in ``gui``, ``drivers`` and ``core``."""
