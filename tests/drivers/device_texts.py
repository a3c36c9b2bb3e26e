"""Device files for the tests."""

GOOD = """\
schema = 1

[device]
name = "Board"
kind = "adc"
layout = "clbacc"

[port]
baud = [115200, 9600]
format = "7E2"
settle_ms = 20
dtr = true

[params]
K = 4

[frame]
sync = "AA .. 55"
length = 12
endian = "big"
nominal_hz = 50
checksum = { alg = "sum8", at = -1, from = 3, to = -1 }
counter = { field = "n", bits = 8, step = 2 }
reject_abs = 5

[[field]]
names = ["n"]
type = "u8"
hide = true

[[field]]
names = ["x", "y"]
type = "i16"
scale = "1/K"
offset = 1
unit = "deg/s"
roles = ["rate.x", "rate.y"]

[[field]]
names = ["flags"]
type = "u8"
at = 9
bits = [1, 2]
endian = "little"

[[command]]
name = "identify"
hex = "AA 00 55 01"
append_checksum = true
repeat = 2
gap_ms = 10
wait_ms = 30
expect_hex = "AA 01"

[command.capture]
serial = { at = 3, type = "uint", size = 4, endian = "big" }
"""

LINES = """\
schema = 1
[device]
name = "Lines"
kind = "imu"
[port]
baud = [9600]
[line]
columns = ["a", "b"]
"""
