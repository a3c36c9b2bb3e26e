"""From numbers to parameters with uncertainties.

result
    `FitResult`: values, covariance, residuals, chi-square, notes.
design
    `Design`: a model over its stimulus, shared by sensors that were measured together.
linear
    Weighted linear least squares of a `SensorModel`.
variance
    What the rows' variances are made of: accumulation, head or table setting.
scatter
    The common scatter of rows without standard errors, beside their setting errors.
lack
    Does the model fit: against the stated uncertainties, and against replicates.
quantiles
    Student t, chi-square and F without loading scipy at start.
"""
