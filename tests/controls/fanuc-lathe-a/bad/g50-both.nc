(expected: 4:1 either axis words or S)
T0101 S500 M3 F.2
G0 X50. Z5.
G50 X1. S500
M30
