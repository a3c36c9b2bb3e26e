"""Translations in the XML of Qt Linguist (``.ts``)."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

from core.errors import FormatError
from core.records.atomic import write_text_atomic


@dataclass(frozen=True, slots=True)
class Message:
    """One text and its translation.

    Parameters
    ----------
    context : by which it is looked up
    source : the English words
    place : file of the sources in which they stand
    translation : empty while there is none
    """

    context: str
    source: str
    place: str = ""
    translation: str = ""


def read_ts(path: Path) -> list[Message]:
    """Return the messages of a file, in its order; an unfinished one has no translation.

    Raises
    ------
    FormatError
        The file cannot be read, or is not of Qt Linguist.
    """
    try:
        root = ElementTree.parse(path).getroot()
    except OSError as error:
        raise FormatError(path, f"cannot be read: {error.strerror}") from error
    except ElementTree.ParseError as error:
        line, column = error.position
        raise FormatError(path, f"is no XML: {error}", line=line, column=column + 1) from error
    if root.tag != "TS":
        raise FormatError(path, f"begins with <{root.tag}>; a file of Qt Linguist with <TS>")
    messages: list[Message] = []
    for context in root.iter("context"):
        name = context.findtext("name", "")
        for entry in context.iter("message"):
            place = entry.find("location")
            words = entry.find("translation")
            done = words is not None and words.get("type") is None
            messages.append(
                Message(
                    name,
                    entry.findtext("source", ""),
                    "" if place is None else place.get("filename", ""),
                    (words.text or "") if done and words is not None else "",
                )
            )
    return messages


def write_ts(path: Path, language: str, messages: Iterable[Message]) -> None:
    """Write a file as Linguist does, contexts in the order of the alphabet.

    Raises
    ------
    StorageError
        It could not be written.
    """
    write_text_atomic(path, ts_text(language, messages))


def ts_text(language: str, messages: Iterable[Message]) -> str:
    """Return the text of a file; see `write_ts`."""
    root = ElementTree.Element("TS", version="2.1", language=language, sourcelanguage="en")
    contexts: dict[str, ElementTree.Element] = {}
    for message in sorted(messages, key=lambda one: one.context):
        context = contexts.get(message.context)
        if context is None:
            context = contexts[message.context] = ElementTree.SubElement(root, "context")
            ElementTree.SubElement(context, "name").text = message.context
        entry = ElementTree.SubElement(context, "message")
        ElementTree.SubElement(entry, "location", filename=f"../../{message.place}")
        ElementTree.SubElement(entry, "source").text = message.source
        words = ElementTree.SubElement(entry, "translation")
        if message.translation:
            words.text = message.translation
        else:
            words.set("type", "unfinished")
    ElementTree.indent(root, "    ")
    body = ElementTree.tostring(root, encoding="unicode", short_empty_elements=True)
    return f'<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n{body}\n'
