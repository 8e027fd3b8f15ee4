(expected: 4:9 PS0053: more than one ',C' or ',R' in one block)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X20. ,C3. ,R2.
Z-9.
M30
