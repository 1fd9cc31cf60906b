"use strict";
(function () {
  const { WIDTH, LEFT, TOP, W, H, FINE } = SIZE;
  function points(d) { // of a path: [[x, y], ..] with gaps as null
    const out = [];
    for (const part of d.split("M").slice(1)) {
      const n = (part.match(/-?\d+/g) || []).map(Number);
      let x = n[0], y = n[1];
      if (out.length) out.push(null);
      out.push([x, y]);
      for (let k = 2; k + 1 < n.length; k += 2) out.push([x += n[k], y += n[k + 1]]);
    }
    return out;
  }
  function at(p, x) { // height of a curve at x, or null
    for (let k = 1; k < p.length; ++k) {
      const a = p[k - 1], b = p[k];
      if (a && b && a[0] <= x && x <= b[0])
        return b[0] === a[0] ? b[1] : a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
    }
    return null;
  }
  const text = (v, range) => {
    const digits = Math.max(0, Math.min(8, 3 - Math.floor(Math.log10(range))));
    return v.toFixed(digits).replace("-", "−");
  };
  for (const figure of document.querySelectorAll("figure")) {
    const svg = figure.querySelector("svg"), line = svg.querySelector(".cur");
    const [x0, x1, y0, y1] = figure.dataset.r.split(" ").map(Number), flat = !figure.dataset.xy;
    const outputs = figure.querySelectorAll(".legend output"), where = figure.querySelector(".at");
    let curves = null, place = 0;
    const value = y => text(y1 - y / (H * FINE) * (y1 - y0), y1 - y0);
    function show(x, y) { // in units of the paths
      if (!curves) curves = [...svg.querySelectorAll("path.cv")].map(p => points(p.getAttribute("d")));
      place = Math.max(0, Math.min(W * FINE, x));
      const px = LEFT + place / FINE, shown = text(x0 + place / (W * FINE) * (x1 - x0), x1 - x0);
      line.setAttribute("x1", px); line.setAttribute("x2", px);
      line.setAttribute("visibility", "visible");
      where.textContent = figure.dataset.x + " " + shown + " " + figure.dataset.xu;
      if (!flat && y !== undefined) where.textContent += ", " + value(y) + " " + figure.dataset.yu;
      curves.forEach((p, k) => {
        const h = flat ? at(p, place) : null;
        if (outputs[k]) outputs[k].textContent = h === null ? "" : value(h) + " " + figure.dataset.yu;
      });
    }
    function hide() {
      line.setAttribute("visibility", "hidden");
      where.textContent = "";
      outputs.forEach(o => { o.textContent = ""; });
    }
    svg.addEventListener("pointermove", e => {
      const box = svg.getBoundingClientRect(), zoom = WIDTH / box.width;
      show(((e.clientX - box.left) * zoom - LEFT) * FINE, ((e.clientY - box.top) * zoom - TOP) * FINE);
    });
    svg.addEventListener("pointerleave", hide);
    svg.addEventListener("blur", hide);
    svg.addEventListener("keydown", e => {
      const step = (e.shiftKey ? 0.1 : 0.01) * W * FINE;
      const to = { ArrowRight: place + step, ArrowLeft: place - step, Home: 0, End: W * FINE }[e.key];
      if (to !== undefined) { show(to); e.preventDefault(); } else if (e.key === "Escape") hide();
    });
  }
}());
