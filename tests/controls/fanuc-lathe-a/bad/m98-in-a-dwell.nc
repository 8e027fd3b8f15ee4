(expected: 4:7 M98 or M99 with other words)
T0101 S500 M3 F.2
G0 X50. Z5.
G4 P5 M98
M30
