(expected: 4:1 X and Z missing in G90, which here is a turning cycle)
T0101 S500 M3 F.2
G0 X50. Z5.
G90 R1.
M30
