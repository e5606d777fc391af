// For the page around a playground: its frame becomes as high as what is in it, and it is told the colours around it.
// Gives back what ends that.
function hostPlayground(frame) {
  let heard = false;
  const clear = /^(transparent|rgba\(.*, 0\))$/;
  const tell = () => {
    if (!frame.isConnected) return; // not yet on the page, or no longer
    let around = frame.parentElement;
    while (around && clear.test(getComputedStyle(around).backgroundColor)) around = around.parentElement;
    const back = around ? getComputedStyle(around).backgroundColor : "rgb(255, 255, 255)";
    const [r, g, b] = back.match(/[\d.]+/g).map(Number), theme = r + g + b < 384 ? "dark" : "light";
    frame.contentWindow?.postMessage({ playground: { theme, back } }, "*");
  };
  const later = () => {
    tell();
    setTimeout(tell, 400); // when a sheet of styles has come, or colours have faded
  };
  const hear = ({ source, data }) => {
    const height = Number(data?.playground?.height);
    if (source !== frame.contentWindow || !(height > 0)) return;
    const border = frame.offsetHeight - frame.clientHeight;
    frame.style.height = `${Math.min(Math.ceil(height), 6000) + border}px`;
    if (!heard) tell(); // it has just begun, and may have missed what it was told
    heard = true;
  };
  const watch = new MutationObserver(later), scheme = matchMedia("(prefers-color-scheme: dark)");
  for (const element of [document.documentElement, document.body]) watch.observe(element, { attributes: true });
  scheme.addEventListener("change", later);
  addEventListener("message", hear);
  later();
  return () => {
    watch.disconnect();
    scheme.removeEventListener("change", later);
    removeEventListener("message", hear);
  };
}
