"""The benchmarks one after another; the exit code tells whether a target was missed.

Called by ``python3 bootstrap.py bench [words in a benchmark's file name]``.
"""

import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent


def main(words: list[str]) -> int:
    """Run those whose names hold one of the words, all without words; return the exit code."""
    missed = 0
    for script in sorted(HERE.glob("bench_*.py")):
        if words and not any(word in script.stem for word in words):
            continue
        print(f"---- {script.stem}", flush=True)
        with subprocess.Popen(
            [sys.executable, "-u", str(script)], stdout=subprocess.PIPE, encoding="utf-8"
        ) as process:
            lines: list[str] = []
            for line in process.stdout or ():
                print(line, end="", flush=True)
                lines.append(line.rstrip())
        here = sum(line.endswith("MISSED") for line in lines)
        if process.returncode != 0 and here == 0:
            print(f"{script.stem} broke off with exit code {process.returncode}")
            here = 1
        missed += here
    print(f"{missed} missed")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
