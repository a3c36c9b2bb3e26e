"""What a subcommand gives back."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Answer:
    """The result of a subcommand.

    Parameters
    ----------
    data : dataclass or mapping, what ``--json`` writes
    text : what a person reads, without a final newline
    code : exit code; 0, or 1 where the work was done and its result is "no"
    """

    data: object
    text: str
    code: int = 0
