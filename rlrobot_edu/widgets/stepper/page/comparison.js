// Two futures side by side: what happened, and what would have happened with the same luck.

// was, other: tapes of the same length, at the same step; from: the step from which on they differ in their settings
function comparisonHtml(about, was, other, from) {
  const { t } = other, both = [["As it was", was], ["What if", other]];
  const columns = both.map(([name, tape]) => {
    const its = aboutAt(about, tape.frame), most = largest(tape.q, about.rMax), shown = windowOf(tape);
    return `<section class="q"><h2>${name}, step ${t}: ${escaped(its.algorithm)}</h2>` +
      `<div class="world">${worldHtml(its, tape, most)}</div>${qHtml(its, tape, shown, [])}</section>`;
  });
  return `${sumsHtml(was, other, from)}<div class="both">${columns.join("")}</div>`;
}

// The sum of all rewards of either, over time.
function sumsHtml(was, other, from) {
  const first = Math.max(was.dropped, other.dropped), { t } = other, n = was.end - first;
  const sums = [was, other].map((tape) => {
    let sum = 0;
    return [0, ...count(n).map((i) => (sum += tape.at(first + i + 1).r))];
  });
  const low = Math.min(...sums.flat()), high = Math.max(...sums.flat()), tall = high - low || 1;
  const line = (sum, kind) => `<polyline class="${kind}" points="${sum.map((y, i) => `${i},${+(high - y).toFixed(4)}`).join(" ")}"/>`;
  const at = (x, kind) => (x < first ? "" : `<path class="${kind}" d="M${x - first},0V${tall}"/>`), parts = partsAt(was, other);
  const words = [`the other begins with step ${from}`, parts === null ? "they go the same way" : `they part in step ${parts}`,
    `sums after step ${was.end}: ${number(sums[0][n])} as it was, ${number(sums[1][n])} what if`];
  return `<svg class="sums" viewBox="0 0 ${n} ${tall}" preserveAspectRatio="none" role="img" aria-label="The sum of rewards: ` +
    `${words.join("; ")}.">${at(from - 1, "from")}${at(t, "now")}${line(sums[0], "was")}${line(sums[1], "other")}</svg>` +
    `<p class="note">Sum of rewards since step ${first}, from ${number(low)} to ${number(high)}: drawn through as it was, dashed what if; ` +
    `${words.join("; ")}. Upright: where the other begins (dotted), and the step shown.</p>`;
}

// The first step in which two tapes are in another state, do something else or get there otherwise; null if there is none.
function partsAt(was, other) {
  for (let t = Math.max(was.dropped, other.dropped) + 1; t <= Math.min(was.end, other.end); t++) {
    const one = was.at(t), two = other.at(t);
    if (one.s !== two.s || one.a !== two.a || one.s2 !== two.s2) return t;
  }
  return null;
}
