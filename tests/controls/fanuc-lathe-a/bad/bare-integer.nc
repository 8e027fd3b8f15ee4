(expected: 4:4 X100 has no decimal point)
T0101 S500 M3 F.2
G0 X50. Z5.
G0 X100
M30
