(expected: 4:4 ',C' is supported only in a G1 line)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 ,C1.
Z-9.
M30
