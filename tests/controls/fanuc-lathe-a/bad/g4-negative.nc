(expected: 4:4 negative dwell time)
T0101 S500 M3 F.2
G0 X50. Z5.
G4 X-1.
M30
