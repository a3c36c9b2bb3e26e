"""Finding out what an unknown board sends, from its bytes alone; nothing here opens a port.

period
    Lengths at which a stream repeats itself, and the bytes that stay the same.
checks
    Checksums tried on frames: the sums, the presets, and CRCs of any polynomial.
polynomials
    The generator of an unknown CRC as the greatest common divisor of differences.
guesses
    Which numbers the varying bytes hold.
lengths
    Both readings of a byte that may tell the length.
pace
    How many frames come in a second: by the clock, or by a number that is the time.
frames, text, analysis
    All of it put together: a proposed description of binary frames or of text lines.
rows
    A stream laid out for the eye, one frame a row, each byte with its part.
written
    A description as the text of a device file.
speeds
    At which speed a port makes sense.
ear
    A decoder that only keeps the latest bytes.
"""
