import csv
import io
from dataclasses import replace

import pytest

from core.procedures.dividing_head import calibrate
from core.records.export_csv import COLUMNS, csv_text, excel_text
from core.records.exports import EXPORTS
from tests.core.procedures.bent_triad import STATED, bent_run
from tests.core.procedures.test_added import FOUND


def rows_of(text, separator):
    return list(csv.reader(io.StringIO(text), delimiter=separator))


def test_numbers_come_back_to_the_last_bit(triad):
    rows = [row for row in rows_of(csv_text(triad), ",") if not row[0].startswith("#")]
    assert tuple(rows[0]) == COLUMNS
    table = [dict(zip(COLUMNS, row, strict=True)) for row in rows[1:]]
    wanted = [
        (name, parameter.name, value, u)
        for name, fit in zip(triad.channels, triad.fits, strict=True)
        for parameter, value, u in zip(fit.parameters, fit.values, fit.stderr, strict=True)
    ]
    found = [
        (row["channel"], row["parameter"], float(row["value"]), float(row["u"]))
        for row in table[: len(wanted)]
    ]
    assert found == wanted
    q = triad.triad().q
    assert {row["parameter"]: float(row["value"]) for row in table[len(wanted) :]} == {
        f"Q_{a}{b}": q[i, j] for i, a in enumerate("xyz") for j, b in enumerate("xyz")
    }
    assert table[-1]["unit"] == "(m/s^2)/code"
    assert float(table[0]["U95"]) > 1.9 * float(table[0]["u"])


def test_the_spreadsheet_form_holds_the_same_numbers(triad):
    plain = rows_of(csv_text(triad), ",")
    local = rows_of(excel_text(triad), ";")
    assert [[cell.replace(",", ".") for cell in row] for row in local] == [
        [cell.replace(",", ".") for cell in row] for row in plain
    ]
    assert not any("." in row[4] for row in local if len(row) > 1 and row[4] != "value")
    assert EXPORTS["excel"].content(triad).startswith(b"\xef\xbb\xbf# device: PW09")
    assert not EXPORTS["csv"].content(triad).startswith(b"\xef\xbb\xbf")


@pytest.mark.parametrize("write", [csv_text, excel_text])
def test_the_head_tells_where_it_comes_from(single, write):
    head = write(single)
    for part in ("# device: Colibrys", "equation: U = ", "# procedure: ", "# local g: ", "# info:"):
        assert part in head
    odd = replace(single, provenance=replace(single.provenance, device="a\nb;c,d"))
    assert all(line.startswith(("#", '"#')) for line in write(odd).splitlines()[:3])


def test_added_effects_stand_in_the_head_and_in_the_table():
    text = csv_text(calibrate(bent_run(), STATED, added=FOUND))
    assert "# added to acc_x: Second-order nonlinearity K2, k * K2 * x^2; of the sensor" in text
    row = next(row for row in rows_of(text, ",") if "second_order" in row)
    assert row[0] == "acc_x"
    assert row[-1] == "mg/g^2"
    assert 5.8 < float(row[4]) < 6.2
