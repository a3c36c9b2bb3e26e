"""Which language the window speaks."""

from importlib.resources import files
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QObject, QTranslator, Signal

from core.errors import FormatError
from gui.languages.shown import Book, speak
from gui.languages.ts_file import read_ts

SYSTEM, ENGLISH = "system", "en"
LANGUAGES = {ENGLISH: "English", "uk": "Українська", "ru": "Русский"}
"""Code and own name of every language; a further one needs its line here and its files."""
_FOLDER = Path(str(files("resources"))) / "i18n"


class Languages(QObject):
    """Installs the words of a language, now and whenever another one is chosen.

    Parameters
    ----------
    choice : a code of `LANGUAGES`, or ``"system"`` for that of the computer
    """

    changed = Signal()
    """Every widget has been told; what is not made of words of its own can be shown again."""

    def __init__(self, choice: str, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.choice = SYSTEM
        self.doubt = ""
        self._installed: list[QTranslator] = []
        self.choose(choice)

    @property
    def spoken(self) -> str:
        """Code of the language on the screen."""
        return language_of_system() if self.choice == SYSTEM else self.choice

    def choose(self, choice: str) -> None:
        """Speak another language; an unknown one stands for that of the system."""
        self.choice = choice if choice in LANGUAGES else SYSTEM
        self.doubt = ""
        for translator in self._installed:
            QCoreApplication.removeTranslator(translator)
        self._installed = []
        code = self.spoken
        locale = locale_of(code)
        QLocale.setDefault(locale)
        speak(self._book(code, locale.decimalPoint()))
        if code != ENGLISH:
            qt_own = QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)
            self._install(f"qtbase_{code}", qt_own)
            self._install(f"calrig_{code}", str(_FOLDER))
        self.changed.emit()

    def _book(self, code: str, decimal: str) -> Book | None:
        if code == ENGLISH:
            return None
        try:
            return Book(read_ts(_FOLDER / f"calrig_{code}.ts"), decimal)
        except FormatError as error:
            self.doubt = str(error)
            return None

    def _install(self, name: str, folder: str) -> None:
        translator = QTranslator(self)
        if translator.load(name, folder):
            QCoreApplication.installTranslator(translator)
            self._installed.append(translator)


def language_of_system() -> str:
    """The first language of the computer that the program speaks; English if there is none."""
    for name in QLocale.system().uiLanguages():
        code = name.partition("-")[0].partition("_")[0]
        if code in LANGUAGES:
            return code
    return ENGLISH


def locale_of(code: str) -> QLocale:
    """The conventions of a language: its decimal mark, and no signs between groups of digits."""
    locale = QLocale.c() if code == ENGLISH else QLocale(code)
    locale.setNumberOptions(QLocale.NumberOption.OmitGroupSeparator)
    return locale
