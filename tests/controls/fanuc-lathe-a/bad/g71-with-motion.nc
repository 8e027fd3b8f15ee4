(expected: 4:1 two G codes that both use the axis words)
T0101 S500 M3 F.2
G0 X50. Z5.
G71 G1 P10 Q20
M30
