"""The subcommands of ``calrig``: everything the window does, without the window.

table
    Which subcommands there are, and the one way in which all of them run.
answer
    What a subcommand gives back: data for programs and text for people.

A subcommand is one module with two functions, and one line in ``table.COMMANDS``::

    def add_arguments(parser: argparse.ArgumentParser) -> None: ...
    def run(args: argparse.Namespace) -> Answer: ...

``run`` computes and returns; it neither prints its result nor catches a ``LabError``. The table
adds ``--json OUT``, prints, writes, and turns an error into one line and exit code 2. Progress of
a long run goes to standard error. No module here imports Qt at its top, so that subcommands work
where no Qt library is installed.
"""
