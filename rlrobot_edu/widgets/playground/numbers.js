// Numbers as the page writes them: with the decimals that show what there is to see.

const NOTHING_YET = 1e-6; // what is less is written as 0.00
const signed = (text) => text.replace(/^-(?=.*[1-9])/, "−").replace("-", "");

// A number with two decimals, or with as many as show that it is not zero.
function number(x) {
  const size = Math.abs(x);
  if (size >= 100) return signed(x.toFixed(size >= 1000 ? 0 : 1));
  const isSmall = size < 0.1 && size >= NOTHING_YET;
  return signed(x.toFixed(isSmall ? 1 - Math.floor(Math.log10(size)) : 2));
}

// Two numbers with as many decimals as tell them apart.
function apart(was, now) {
  const written = (decimals) => [was, now].map((x) => signed(x.toFixed(decimals)));
  let decimals = 2;
  while (was !== now && decimals < 12 && written(decimals)[0] === written(decimals)[1]) decimals += 1;
  return written(decimals);
}
