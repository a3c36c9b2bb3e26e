"""The documentation: every page is found, every link and picture leads somewhere."""

import re
from pathlib import Path

import pytest

from core.certificates.laboratory import read_laboratory
from drivers.virtual.address import rig_of
from gui.commands.table import COMMANDS

ROOT = Path(__file__).resolve().parents[1]
DOCS = ROOT / "docs"
PAGES = sorted([*ROOT.glob("*.md"), *DOCS.rglob("*.md")])
_LINK = re.compile(r"\]\(([^)#\s]*)(?:#([^)\s]+))?\)")


def links_of(page: Path) -> list[tuple[Path, str]]:
    """The files that a page names, each with the place in it that is meant."""
    return [
        ((page.parent / target).resolve() if target else page, anchor)
        for target, anchor in _LINK.findall(page.read_text("utf-8"))
        if "://" not in target
    ]


def anchors_of(page: Path) -> set[str]:
    """The headings of a page as a browser of the repository names them."""
    headings = re.findall(r"^#+ (.*)$", page.read_text("utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def test_the_entry_names_every_page():
    entry = DOCS / "README.md"
    named = {target for target, _ in links_of(entry)}
    forgotten = [page for page in DOCS.rglob("*.md") if page != entry and page not in named]
    assert forgotten == []


def test_a_place_within_a_page_exists():
    broken = [
        f"{page.relative_to(ROOT)}: {target.name}#{anchor}"
        for page in PAGES
        for target, anchor in links_of(page)
        if anchor and anchor not in anchors_of(target)
    ]
    assert broken == []


def test_every_picture_is_shown_in_some_page_in_one_of_its_looks():
    look = re.compile(r"-(dark|light)\.png$")
    shown = {look.sub("", target.name) for page in PAGES for target, _ in links_of(page)}
    kept = {look.sub("", path.name) for path in (DOCS / "pictures").iterdir()}
    assert sorted(kept - shown) == []


def test_the_guide_shows_every_tab_of_the_window():
    source = (ROOT / "gui" / "app.py").read_text("utf-8")
    titles = re.findall(r'^    "([A-Z][\w ]+)": "gui\.\w+\.tab",$', source, re.MULTILINE)
    assert len(titles) > 10
    guide = (DOCS / "guide" / "README.md").read_text("utf-8")
    assert [title for title in titles if f"| {title} |" not in guide] == []


def test_the_laboratory_that_is_shown_can_be_read(tmp_path: Path):
    page = (DOCS / "certificate.md").read_text("utf-8")
    (example,) = re.findall(r"```json\n(.*?)```", page, re.DOTALL)
    path = tmp_path / "laboratory.json"
    path.write_text(example, "utf-8")
    assert read_laboratory(path).standards[0].serial == "114"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_commands_and_rigs_that_a_page_names_exist(page: Path):
    text = page.read_text("utf-8")
    named = set(re.findall(r"(?:^ *|`)calrig ([a-z][a-z-]*)", text, re.MULTILINE))
    assert named - set(COMMANDS) == set()
    for address in re.findall(r'"(sim://\w[^"]*)"', text):
        rig_of(address)


@pytest.mark.parametrize("page", sorted(DOCS.rglob("*.md")), ids=lambda page: page.stem)
def test_sources_that_a_page_names_exist(page: Path):
    places = re.findall(
        r"`((?:core|drivers|gui|tests|resources)/[\w/.]+)`", page.read_text("utf-8")
    )
    assert [place for place in places if not (ROOT / place).exists()] == []
