"""The wheel holds the whole program and works from a clean environment."""

import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
TRACKED = ("calrig", "core", "drivers", "gui", "resources")


def run(*command: str, cwd: Path) -> str:
    done = subprocess.run(command, cwd=cwd, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel, built of a copy: setuptools leaves its own folders beside the sources."""
    folder = tmp_path_factory.mktemp("wheel")
    listed = run("git", "ls-files", *TRACKED, "pyproject.toml", "README.md", "LICENSE", cwd=ROOT)
    for name in listed.splitlines():
        source, copy = ROOT / name, folder / "sources" / name
        if source.exists():
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_bytes(source.read_bytes())
    pip = (sys.executable, "-m", "pip", "wheel", "--no-deps", "--no-build-isolation", "--no-index")
    run(*pip, "--wheel-dir", str(folder), str(folder / "sources"), cwd=folder)
    (built,) = folder.glob("calrig-*.whl")
    return built


def test_every_file_travels_and_nothing_lies_open_in_site_packages(wheel: Path):
    inside = set(zipfile.ZipFile(wheel).namelist())
    tops = {name.split("/")[0] for name in inside if ".dist-info" not in name}
    assert tops == {"calrig"}
    tracked = run("git", "ls-files", *TRACKED, cwd=ROOT).splitlines()
    wanted = {
        name if name.startswith("calrig/") else f"calrig/_app/{name}"
        for name in tracked
        if (ROOT / name).exists()
    }
    assert wanted - inside == set()


def test_it_runs_from_a_clean_environment(wheel: Path, tmp_path: Path):
    run(sys.executable, "-m", "venv", "--without-pip", str(tmp_path / "clean"), cwd=tmp_path)
    scripts = "Scripts" if sys.platform == "win32" else "bin"
    python = tmp_path / "clean" / scripts / "python"
    where = "import sysconfig; print(sysconfig.get_path('purelib'))"
    site = Path(run(str(python), "-c", where, cwd=tmp_path).strip())
    # Its dependencies, which pip would fetch, are those of this environment.
    here = Path(run(sys.executable, "-c", where, cwd=tmp_path).strip())
    (site / "dependencies.pth").write_text(f"{here}\n", encoding="utf-8")
    run(
        *(sys.executable, "-m", "pip", f"--python={python}", "install", "--no-deps", "--no-index"),
        str(wheel),
        cwd=tmp_path,
    )
    calrig = tmp_path / "clean" / scripts / "calrig"
    assert run(str(calrig), "--version", cwd=tmp_path).startswith("calrig ")
    run_file = "# calrig-run = 1\n" + (
        '# test = "dividing_head"\n# sensor = "accelerometer"\n# axis = "z"\n'
        '# output_unit = "V"\n# g_mps2 = 9.8106\n'
        "run,order,mount,head_deg,y\n"
        "0,0,X_from,0,3.5\n0,1,X_from,90,2.5\n0,2,X_from,180,1.5\n0,3,X_from,270,2.5\n"
    )
    (tmp_path / "four.run.csv").write_text(run_file, encoding="utf-8")
    assert "k_z" in run(str(calrig), "fit", "four.run.csv", cwd=tmp_path)
