
/** Mouse and touch on the drawing: one pointer turns (with the right button or Shift it shifts), two shift and zoom. */
function listenToPointers(canvas, camera, changed, fit) {
  const down = new Map();
  const from = (event) => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left - box.width / 2, y: event.clientY - box.top - box.height / 2 };
  };
  const pair = () => {
    const [one, other] = [...down.values()];
    return { x: (one.x + other.x) / 2, y: (one.y + other.y) / 2, apart: Math.hypot(one.x - other.x, one.y - other.y) };
  };
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, { ...from(event), shifts: event.button === 2 || event.button === 1 || event.shiftKey });
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = down.get(event.pointerId);
    if (!before) return;
    const height = canvas.clientHeight, now = from(event);
    if (down.size === 1) {
      if (before.shifts) camera().shift(now.x - before.x, now.y - before.y, height);
      else camera().turn(now.x - before.x, now.y - before.y);
      down.set(event.pointerId, { ...before, ...now });
    } else if (down.size === 2) {
      const old = pair();
      down.set(event.pointerId, { ...before, ...now });
      const next = pair();
      camera().shift(next.x - old.x, next.y - old.y, height);
      if (old.apart > 0 && next.apart > 0) camera().zoom(next.apart / old.apart, next.x, next.y, height);
    }
    changed();
  });
  const up = (event) => down.delete(event.pointerId);
  canvas.addEventListener("pointerup", up);
  canvas.addEventListener("pointercancel", up);
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const step = event.deltaMode === 1 ? 30 : 1, at = from(event);
      camera().zoom(Math.exp(-event.deltaY * step * 0.0015), at.x, at.y, canvas.clientHeight);
      changed();
    },
    { passive: false },
  );
  canvas.addEventListener("dblclick", () => {
    fit();
  });
}
