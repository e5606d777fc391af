// How the page fits into what is around it: colours, and the height of a frame. In a frame see host_page.js.

const isFramed = window !== window.parent;

// Calls `changed` when the colours are others.
function followTheme(changed) {
  matchMedia("(prefers-color-scheme: dark)").onchange = changed;
  addEventListener("message", ({ source, data }) => {
    const told = data && data.playground;
    if (source !== window.parent || !told || !["light", "dark"].includes(told.theme)) return;
    document.documentElement.dataset.theme = told.theme;
    if (CSS.supports("color", told.back)) document.documentElement.style.setProperty("--back", told.back);
    changed();
    tellHeight();
  });
}

function tellHeight() {
  window.parent.postMessage({ playground: { height: document.body.getBoundingClientRect().height } }, "*");
}

if (isFramed) {
  document.documentElement.classList.add("framed");
  new ResizeObserver(tellHeight).observe(document.body);
}
