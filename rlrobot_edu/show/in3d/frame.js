// A page in a frame of the notebook. All that has come is kept for frames that are opened later: while the kernel is
// busy, when it has ended, and in a saved notebook, which saves what the model holds.
const kept = new Map();
let rewards = [], count = 0;
function keep(told, buffers) {
  told.keys.forEach((key, i) => {
    const [path, kind] = key, name = JSON.stringify(key);
    if (kind !== "delete") return kept.set(name, buffers[i]);
    for (const old of kept.keys()) if (`${JSON.parse(old)[0]}/`.startsWith(`${path}/`)) kept.delete(old);
  });
  ({ rewards, count } = told);
}
export default {
  initialize({ model }) {
    const scene = model.get("scene");
    keep(scene, scene.packed);
    model.on("msg:custom", (told, buffers) => {
      keep(told, buffers);
      model.set("scene", { keys: [...kept.keys()].map((key) => JSON.parse(key)), packed: [...kept.values()], rewards, count });
    });
  },
  render({ model, el }) {
    const frame = Object.assign(document.createElement("iframe"), { title: "A robot in 3D" });
    frame.sandbox = "allow-scripts"; // no script of it reaches the notebook around it
    frame.style = `width: 100%; height: ${model.get("height")}px; border: 0; color-scheme: light`;
    frame.srcdoc = model.get("page");
    const pass = (told, commands) => frame.contentWindow?.postMessage({ rewards, count, commands }, "*");
    const answer = ({ source }) => { if (source === frame.contentWindow) pass(null, [...kept.values()]); };
    addEventListener("message", answer);
    model.on("msg:custom", pass);
    el.append(frame);
    return () => {
      removeEventListener("message", answer);
      model.off("msg:custom", pass);
    };
  },
};
