"""`calrig means`: records of a folder to means, to a run file, to the fit of the table."""

import json

import numpy as np
import pytest

from core.arrays import frozen, frozen_int
from core.records.cvgcom import CvgcomFile, CvgcomHead, channel_of
from core.records.cvgcom_writer import write_cvgcom
from core.records.means import read_means
from core.records.run_file import read_run
from core.samples.block import SampleBlock
from drivers.recorder import Recorder, RecordLayout
from gui.commands.table import REFUSED, run_command

CHANNELS = (channel_of("GyroOut"), channel_of("Temperature"))
RATES = (10.0, -10.0, 20.0)


@pytest.fixture
def folder(tmp_path):
    rng = np.random.default_rng(5)
    for number, rate in enumerate(RATES, 1):
        data = rng.normal([0.024 * rate, 26.0], 1e-4, size=(500, 2))
        stem = f"25-143.exp({number:03d})_d_pr1"
        if number == 2:
            writer = Recorder(tmp_path / f"{stem}.calrec", {}, RecordLayout(CHANNELS, 100.0))
            writer.say(SampleBlock(CHANNELS, frozen_int(range(500)), frozen(data), 100.0))
            writer.close()
        head = CvgcomHead(0.01, 0.024, CHANNELS)
        path = tmp_path / f"{stem}.txt"
        write_cvgcom(CvgcomFile(path, head, frozen(data), None, ()), path)
    return tmp_path


def test_means_and_run(folder, capsys):
    run_file = folder / "rates.run.csv"
    arguments = [str(folder), "--rates", "10,-10,20", "--run", str(run_file), "--json", "-"]
    assert run_command("means", arguments) == 0
    found = json.loads(capsys.readouterr().out)
    assert [one["n"] for one in found["means"]] == [500, 500, 500]
    names = [one.record for one in read_means(folder / "means.dat")]
    assert names[1] == "25-143.exp(002)_d_pr1.calrec"
    run = read_run(run_file)
    assert run.device == "25-143"
    assert run.y[:, 0] == pytest.approx([0.24, -0.24, 0.48], abs=1e-4)
    assert run.set_rate_dps.tolist() == list(RATES)


def test_intervals(folder, capsys):
    assert run_command("means", [str(folder), "--interval", "0:1", "--interval", "2:4"]) == 0
    assert "25-143.exp(001)_d_pr1.txt[2..4]  n 200" in capsys.readouterr().out


@pytest.mark.parametrize("extra", [["--interval", "5"], ["--rates", "1", "--run", "x.run.csv"]])
def test_wrong_words_are_refused(folder, extra, capsys):
    assert run_command("means", [str(folder), *extra]) == REFUSED
    assert capsys.readouterr().err.startswith("calrig means: ")


def test_an_empty_folder_is_refused(tmp_path, capsys):
    assert run_command("means", [str(tmp_path)]) == REFUSED
    assert "no records" in capsys.readouterr().err
