// The page begins: it unpacks the viewer and the scene, and listens to the page around it.
async function open() {
  const program = new TextDecoder().decode(await inflate(bytesOf(library.textContent)));
  document.head.append(Object.assign(document.createElement("script"), {textContent: program}));
  onmessage = null;  // meshcat's GIF encoder would take each message for a frame, answer it to itself, and so on for ever
  begin();
  const rewards = JSON.parse(paid.textContent);
  await hear({packed: bytesOf(scene.textContent), commands: [], rewards, count: rewards.length});
  requestAnimationFrame(tick);
  if (still) requestAnimationFrame(() => requestAnimationFrame(() => { pending.contentDocument.close(); pending.remove(); }));
  const whole = ({buffer, byteOffset, byteLength}) => new Uint8Array(buffer, byteOffset, byteLength);
  addEventListener("message", ({source, data}) => {
    if (source === parent) hear({...data, packed: data.packed && whole(data.packed), commands: data.commands.map(whole)});
  });
  if (self !== top) parent.postMessage("ready", "*");  // what came before is told now
}
// A browser draws only some sixteen views at once; the oldest ones lose their picture, and take it back when they are seen.
const isLost = () => Boolean(viewer?.renderer.getContext().isContextLost());
new IntersectionObserver(([{isIntersecting}]) => { if (isIntersecting && isLost()) location.reload(); }).observe(view);
open().catch(error => {
  if (bar.hidden && !isLost()) say("This page cannot be unpacked: the browser is older than 2023, or the file is damaged.");
  throw error;
});
