"""The result of a noise fit: a table of coefficients by method."""

from dataclasses import dataclass

from core.allan.curve import AllanCurve
from core.allan.model import NoiseModel
from core.errors import Note


@dataclass(frozen=True, slots=True)
class NoiseRow:
    """One coefficient by one method.

    Parameters
    ----------
    term : key of TERMS
    symbol : its letter in (6.4)
    value : best estimate; may be 0 where `upper_limit` is set
    u : standard uncertainty; for an upper limit (upper - value) / 1.645
    lower, upper : 95 % interval; for an upper limit 0 and the one-sided 95 % limit
    unit : of all four
    method : ``"likelihood"``, ``"least_squares"`` or ``"graphical"``
    upper_limit : the term is not detected: quote "< upper" only
    """

    term: str
    symbol: str
    value: float
    u: float
    lower: float
    upper: float
    unit: str
    method: str
    upper_limit: bool


@dataclass(frozen=True, slots=True, eq=False)
class NoiseCoefficients:
    """All that was found about the noise of a record.

    Parameters
    ----------
    rows : first the values to publish (``"likelihood"``), then the other methods
    model : the published values, undetected terms at 0
    curve : the Allan curve with degrees of freedom and limits under the fitted model
    band : highest frequency fitted, Hz
    shortest : shortest tau fitted by least squares, s
    unit : unit of the record
    notes : doubts
    """

    rows: tuple[NoiseRow, ...]
    model: NoiseModel
    curve: AllanCurve
    band: float
    shortest: float
    unit: str
    notes: tuple[Note, ...]

    def row(self, term: str, method: str = "likelihood") -> NoiseRow:
        """Return one row; KeyError where this method has none of this term."""
        for one in self.rows:
            if one.term == term and one.method == method:
                return one
        raise KeyError(f"{method} gives no {term}")
