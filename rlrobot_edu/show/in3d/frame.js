// A page in a frame of the notebook. All that has come is kept for frames that are opened later: while the kernel is
// busy, when it has ended, and in a saved notebook, which saves what the model holds.
const AGAIN = "The view in 3D is not kept in this notebook: run this cell again.";

function later(model, told, buffers) {
  const scene = model.get("scene"), news = new Map(scene.keys.map((key, i) => [JSON.stringify(key), scene.news[i]]));
  told.keys.forEach((key, i) => {
    const [path, kind] = key, name = JSON.stringify(key);
    if (kind === "delete") {
      for (const old of news.keys()) if (`${JSON.parse(old)[0]}/`.startsWith(`${path}/`)) news.delete(old);
    }
    news.delete(name);  // the newest comes last
    news.set(name, buffers[i]);
  });
  const keys = [...news.keys()].map((name) => JSON.parse(name));
  model.set("scene", { ...told, keys, packed: scene.packed, news: [...news.values()] });
}

// The colours around the frame, light or dark
function themeAround(frame) {
  for (let around = frame.parentElement; around; around = around.parentElement) {
    const [r, g, b, opacity = 1] = getComputedStyle(around).backgroundColor.match(/[\d.]+/g).map(Number);
    if (opacity) return r + g + b < 384 ? "dark" : "light";
  }
  return "light";
}

async function pageOf(model) {
  const name = model.get("viewer");  // "IPY_MODEL_" and the viewer's number
  const viewer = await model.widget_manager.get_model(name.replace("IPY_MODEL_", ""));
  return viewer.get("page");
}

export default {
  initialize({ model }) {
    model.on("msg:custom", (told, buffers) => later(model, told, buffers));
  },
  async render({ model, el }) {
    const frame = Object.assign(document.createElement("iframe"), { title: "A robot in 3D" });
    frame.sandbox = "allow-scripts"; // no script of it reaches the notebook around it
    frame.style = `display: block; width: 100%; aspect-ratio: 4 / 3; max-height: ${model.get("height")}px; border: 0`;
    try {
      frame.srcdoc = await pageOf(model);
    } catch {
      el.textContent = AGAIN;
      return;
    }
    const send = (told, commands, packed) => {
      const { rewards, count, title } = told;
      frame.contentWindow?.postMessage({ rewards, count, title, commands, packed, theme: themeAround(frame) }, "*");
    };
    const whole = () => send(model.get("scene"), model.get("scene").news, model.get("scene").packed);
    const answer = ({ source }) => { if (source === frame.contentWindow) whole(); };
    const pass = (told, buffers) => send(told, buffers);
    const repaint = () => send(model.get("scene"), []);
    const watch = new MutationObserver(() => setTimeout(repaint, 400)); // when the colours have faded
    for (const element of [document.documentElement, document.body]) watch.observe(element, { attributes: true });
    addEventListener("message", answer);
    model.on("msg:custom", pass);
    el.append(frame);
    return () => {
      watch.disconnect();
      removeEventListener("message", answer);
      model.off("msg:custom", pass);
    };
  },
};
