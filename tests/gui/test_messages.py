"""One banner at a time, and a log of everything."""

from core.errors import FormatError, LinkError, Severity, StorageError
from gui.messages import Messages
from gui.widgets.states import BannerState


def info(what: str) -> BannerState:
    return BannerState(Severity.INFO, what)


def test_the_most_severe_is_shown_then_the_newest():
    messages = Messages()
    messages.show("a", info("first"))
    messages.show("b", BannerState(Severity.WARNING, "doubt"))
    messages.show("c", info("later"))
    assert messages.current == BannerState(Severity.WARNING, "doubt")
    messages.clear("b")
    assert messages.current == info("later")
    messages.clear("c")
    assert messages.current == info("first")


def test_a_source_tells_its_newest_truth_and_everything_is_logged():
    messages = Messages()
    logged: list[str] = []
    messages.logged.connect(lambda entry: logged.append(entry.text))
    messages.show("a", info("one"))
    messages.show("a", info("one"))
    messages.show("a", info("two"))
    messages.clear("a")
    assert messages.current is None
    assert logged == ["one", "two"]


def test_a_button_goes_to_the_source_that_is_shown():
    messages = Messages()
    pressed: list[tuple[str, str]] = []
    messages.action.connect(lambda source, key: pressed.append((source, key)))
    messages.press("nobody")
    messages.show("a", info("one"))
    messages.show("b", BannerState(Severity.ERROR, "two"))
    messages.press("retry")
    messages.dismiss()
    messages.press("ok")
    assert pressed == [("b", "retry"), ("a", "ok")]


def test_the_words_of_errors():
    messages = Messages()
    messages.tell_error("l", "No link", LinkError("COM4", "the port is busy", "close it"))
    banner = messages.current
    assert banner is not None
    assert (banner.what, banner.meaning, banner.remedy) == (
        "No link: COM4",
        "The port is busy.",
        "Close it.",
    )
    messages.tell_error("s", "Not stored", StorageError("/data/x: disk full"))
    banner = messages.current
    assert banner is not None
    assert banner.meaning == "/data/x: disk full."
    assert banner.remedy.startswith("Make room there")
    messages.tell_error("f", "Not loaded", FormatError("a.txt", "no numbers", line=3))
    banner = messages.current
    assert banner is not None
    assert banner.remedy.startswith("Nothing was changed")
    messages.clear("f")
