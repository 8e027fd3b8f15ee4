(expected: 4:9 ,R3 has no decimal point)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X20. ,R3
Z-9.
M30
