
/** The page is written anew with every save of its workbook: it is loaded again while nobody uses it, and stands as before. */
{
  const EVERY = 2000, IDLE = 4000, KEPT = `rodete ${location.pathname}`;
  const KEPT_OF_CAMERA = ["azimuth", "elevation", "flat", "half", "section", "target", "untouched"];
  let used = -Infinity;
  for (const event of ["pointerdown", "pointermove", "wheel", "keydown", "touchstart"]) {
    addEventListener(event, () => (used = performance.now()), { passive: true });
  }
  try {
    const kept = JSON.parse(sessionStorage.getItem(KEPT) ?? "null");
    sessionStorage.removeItem(KEPT);
    if (kept && !location.hash) {
      switchLanguage(kept.language);
      chooseProgram(kept.program);
      shownPreset = kept.preset;
      Object.assign(camera, kept.camera);
      goTo(Math.min(kept.cursor, run.count));
      ask();
    }
  } catch {
    // A browser that keeps nothing for a file begins anew.
  }
  setInterval(() => {
    if (playing || document.hidden || performance.now() - used < IDLE) return;
    const seen = Object.fromEntries(KEPT_OF_CAMERA.map((name) => [name, camera[name]]));
    try {
      sessionStorage.setItem(KEPT, JSON.stringify({ language, program, cursor, preset: shownPreset, camera: seen }));
    } catch {
      // It begins anew.
    }
    location.reload();
  }, EVERY);
}
