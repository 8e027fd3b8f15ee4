;expected: 3:8 K0.5 in G4
%P,MX,
N10 G4 K0.5
M30
