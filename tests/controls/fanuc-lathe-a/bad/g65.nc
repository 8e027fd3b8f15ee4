(expected: 4:1 G65 is not supported: macros)
T0101 S500 M3 F.2
G0 X50. Z5.
G65 P1
M30
