"""Every widget test starts from the light look."""

import pytest

from gui.widgets.theme import apply_theme


@pytest.fixture(autouse=True)
def _light(qapp):
    apply_theme(qapp, "light")
