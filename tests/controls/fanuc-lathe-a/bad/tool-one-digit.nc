(expected: 2:1 names no place of the turret)
T3
M30
