(expected: 4:1 G53 without G0 or G1)
T0101 S500 M3 F.2
G0 X50. Z5.
G53 G2 X10. Z0 R20.
M30
