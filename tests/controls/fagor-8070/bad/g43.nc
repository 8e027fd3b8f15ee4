;expected: 3:1 G43 is not known to rodete in the dialect fagor-8070; check the number
G71 G90 G94 F100
G43
M30
