(expected: 4:15 R5 reaches the end by half a circle)
T0101 S500 M3 F.2
G0 X20. Z0.
G3 X20. Z-10. R5.
M30
