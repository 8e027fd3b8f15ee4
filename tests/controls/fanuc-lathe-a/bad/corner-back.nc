(expected: 4:9 the two lines run back along each other)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X20. ,R3.
X30.
M30
