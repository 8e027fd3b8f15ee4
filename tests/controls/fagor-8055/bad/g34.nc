;expected: 3:1 G34 is not known to rodete in the dialect fagor-8055; check the number
G71 G90 G94 F100
G34 Z1
M30
