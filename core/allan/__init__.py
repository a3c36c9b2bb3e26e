"""Allan analysis of a rate record: the curve, its confidence, the noise coefficients.

record.py       survey of the input: gaps, integer codes, uniform time
faults.py       stuck and clipped samples
taus.py         the choice of averaging factors
deviation.py    the curve of a whole record: exact blocked algorithm, or the equivalent one
squares.py      the innermost sum
streaming.py    the curve of a record that still grows (multi-tau), in O(log n) memory
curve.py        AllanCurve, the frozen result of both
confidence.py   noise identification, equivalent degrees of freedom, chi-square intervals
covariance.py   the exact covariances behind both the degrees of freedom and the fit
model.py        the five noise terms of (6.4): the one table that knows their laws
spectrum.py     cosine-transform power of a record, in bins
whittle.py      maximum likelihood on those bins, automatic band, profile intervals
leastsquares.py non-negative least squares on the Allan variance, sandwich covariance
graphical.py    the reading of the curve with a ruler (lab 6)
ramp.py         a steady drift of the rate beside the noise
noise.py        fit_noise: all methods in one table
coefficients.py NoiseRow and NoiseCoefficients, that table
rows.py         one function a method that fills it
conventions.py  the same coefficient in every unit and convention people quote
other.py        Hadamard, modified and total deviations by an optional library
preview.py      what a record k times longer would resolve
detrend.py      regression on temperature and other channels
"""
