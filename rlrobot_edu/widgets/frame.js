// A page in a frame of the notebook. All that has come is kept for frames that are opened later, also while the kernel is
// busy or when it has ended.
const told = { room: null, frames: [], closed: false };
function keep({ room, frames, closed }) {
  if (room) Object.assign(told, { room, frames: [] });
  told.frames = [...told.frames, ...frames].slice(-2000);
  told.closed = closed;
}
export default {
  initialize({ model }) {
    keep(model.get("news"));
    model.on("msg:custom", keep);
  },
  render({ model, el }) {
    const frame = Object.assign(document.createElement("iframe"), { title: "Live 3D view of the robot" });
    frame.sandbox = "allow-scripts"; // no script of it reaches the notebook around it
    frame.style = "width: 100%; height: 480px; border: 0; color-scheme: light";
    frame.srcdoc = model.get("page");
    const pass = (news) => frame.contentWindow?.postMessage(news, "*");
    const answer = ({ source }) => { if (source === frame.contentWindow) pass(told); };
    addEventListener("message", answer);
    model.on("msg:custom", pass);
    el.append(frame);
    return () => {
      removeEventListener("message", answer);
      model.off("msg:custom", pass);
    };
  },
};
