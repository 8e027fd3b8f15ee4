(expected: 4:1 two G codes of one modal group)
T0101 S500 M3 F.2
G0 X50. Z5.
G90 G0 X10.
M30
