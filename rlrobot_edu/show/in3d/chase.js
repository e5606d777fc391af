// Where the camera of the view stands: it follows the robot, goes round it, and listens to mouse and wheel.
let stands = [], taken;  // one for each shape of a picture, from tall to wide, and the present one
function placesOf(command) {
  ({stands} = command);
  taken = undefined;
  viewer.set_3d_pane_size();
}

// Stand where the whole room is seen on a picture of this shape, width over height.
function standFor(aspect) {
  const fitting = stands.findLast(each => each.aspect <= aspect) ?? stands[0];
  if (!fitting) return;
  viewer.camera.zoom = Math.min(1, aspect / fitting.aspect);  // still taller, and the whole width is seen
  if (fitting === taken) return;  // lest a reader's own view be lost
  taken = fitting;
  const {target, eye: [x, y, z]} = fitting;
  node(["Cameras", "default"]).position.set(...target);
  viewer.camera.position.set(x, z, -y);  // the y axis of this frame points upward
  viewer.controls.target.set(0, 0, 0);
}

const pressed = button => button.getAttribute("aria-pressed") === "true";
const chasing = () => pressed(chase);
const yaw = q => Math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
const rolls = () => node(["meshcat", "robot"])?.children.some(({name}) => name.endsWith("_wheel"));
let heading = 0, height = 0, whole;
function follow(seconds) {  // the camera's frame, Cameras/default, moves with the robot
  const {position: {x, y, z}, quaternion} = body(), aim = node(["Cameras", "default"]);
  const behind = yaw(quaternion) - heading, shortest = Math.atan2(Math.sin(behind), Math.cos(behind));
  heading += shortest * (1 - Math.exp(-2.5 * seconds));
  aim.position.set(x, y, Math.max(z, 0.4 * height));
  aim.rotation.set(0, 0, heading);
}
chase.onclick = () => {
  chase.setAttribute("aria-pressed", !chasing());
  const {camera, controls} = viewer, aim = node(["Cameras", "default"]), robot = node(["meshcat", "robot"]);
  viewer.set_dirty();
  if (!chasing()) {
    aim.position.copy(whole.aim);
    aim.rotation.set(0, 0, 0);
    camera.position.copy(whole.eye);
    controls.target.copy(whole.target);
    return;
  }
  whole = {aim: aim.position.clone(), eye: camera.position.clone(), target: controls.target.clone()};
  controls.target.set(0, 0, 0);
  heading = yaw(body().quaternion);
  height = new MeshCat.THREE.Box3().setFromObject(robot).max.y;
  const back = rolls() ? 1.1 + 0.8 * height : 1.8 * height, from = rolls() ? Math.PI : -1.2;  // from behind an arm would hide its own gripper
  camera.position.set(back * Math.cos(from), 0.6 * back, -back * Math.sin(from));
  follow(0);
};
turn.onclick = () => turn.setAttribute("aria-pressed", !pressed(turn));
function goRound(seconds) {  // about the point at which it looks
  const {camera, controls} = viewer, up = new MeshCat.THREE.Vector3(0, 1, 0);
  camera.position.sub(controls.target).applyAxisAngle(up, 0.4 * seconds).add(controls.target);
  viewer.set_dirty();
}
// the wheel scrolls the page until somebody clicks into the picture
view.addEventListener("pointerdown", () => { viewer.controls.enableZoom = hint.hidden = true; });
view.addEventListener("pointerleave", () => { viewer.controls.enableZoom = false; hint.hidden = true; });
view.addEventListener("wheel", () => { hint.hidden = viewer.controls.enableZoom; }, {passive: true});

// The controls keep their target in the frame of Cameras/default, but turn the camera as if that were the world's.
function aimAtTarget(controls, camera) {
  const update = controls.update.bind(controls);
  controls.update = () => {
    const hasMoved = update();
    if (!camera.parent) return hasMoved;  // it is not in the scene yet
    camera.parent.updateWorldMatrix(true, false);
    camera.lookAt(camera.parent.localToWorld(controls.target.clone()));
    return hasMoved;
  };
}
