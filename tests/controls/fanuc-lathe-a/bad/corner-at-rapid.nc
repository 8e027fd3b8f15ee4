(expected: 4:9 ',C' is supported only in a G1 line)
T0101 S500 M3 F.2
G0 X50. Z5.
G0 X20. ,C1.
G1 Z-5.
M30
