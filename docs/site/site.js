// Code and tables that are wider than the page can be scrolled by keys, too.
function reachable() {
  for (const box of document.querySelectorAll("pre, .table-wrapper, .cell_output .output, div.math")) {
    if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
    else box.removeAttribute("tabindex");
  }
}
addEventListener("load", reachable);
// The frame of a playground or a stage is as high as what is in it, and follows the switch between light and dark; see host_page.js.
addEventListener("load", () => {
  document.querySelectorAll("iframe:is(.playground, .playgrounds, .stage, .stages)").forEach(hostPlayground);
});
addEventListener("resize", reachable);
// Both columns beside a page are landmarks; by their names a screen reader tells them apart.
addEventListener("load", () => {
  for (const [column, name] of [["sidebar", "All pages"], ["toc", "On this page"]]) {
    document.querySelector(`aside.${column}-drawer`)?.setAttribute("aria-label", name);
  }
});
