(expected: 6:13 tool 12 is not in the tool table)
T0101 S500 M3 F.2
G0 X50. Z5.
G71 U2. R1.
G71 P10 Q20
N10 G0 X30. T1212
G1 Z1.
N20 X50.
M30
