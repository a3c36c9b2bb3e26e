"""Samples on their way from the decoder to a fit.

block
    `Channel` and `SampleBlock`: what a decoder gives.
accumulate, mean_error
    `Accumulator`: N seconds by the device's counter -> `Accumulation`.
turning
    Angles that begin anew after a full turn.
stillness
    Has the head come to rest, did it move meanwhile.
running
    Mean and standard deviation while samples come.
run
    `Run`: the accumulated rows of one test, the input of every procedure.
"""
