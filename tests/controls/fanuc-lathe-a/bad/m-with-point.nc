(expected: 3:1 M3. has a decimal point)
T0101 S500 F.2
M3.
G0 X50. Z5.
M30
