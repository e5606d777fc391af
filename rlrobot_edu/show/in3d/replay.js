// A film's places, which replay.py packs, become an animation of meshcat's: a key for each step.
function animationsOf({names, moves, rate, put}) {
  const {Matrix4, Vector3, Quaternion} = MeshCat.THREE;
  const numbers = new Float32Array(Uint8Array.from(moves).buffer), steps = numbers.length / names.length / 12;
  return names.map((name, k) => {
    const tracks = [[".position", "vector3"], [".quaternion", "quaternion"], [".scale", "vector3"]]
      .map(([property, type]) => ({name: property, type, keys: []}));
    const key = (step, time) => {
      const m = i => numbers[(12 * k + i) * steps + step], parts = [new Vector3(), new Quaternion(), new Vector3()];
      if (isNaN(m(0))) return;  // it is not in this scene
      new Matrix4().set(...[...Array(12).keys()].map(m), 0, 0, 0, 1).decompose(...parts);
      tracks.forEach(({keys}, i) => keys.push({time, value: parts[i].toArray()}));
    };
    for (let step = 0; step < steps; step++) {
      if (put.includes(step)) key(step - 1, step - 0.01);  // no glide through the room
      key(step, step);
    }
    return {path: "/meshcat/" + name, clip: {fps: rate, name, tracks}};
  });
}

// A laser measures at whole steps: between two of them its beam stays as it was measured.
function jumpIfBeam({path, clip}) {
  if (!path.includes("beams")) return;  // a list of names
  for (const track of clip.tracks) {
    track.interpolation = MeshCat.THREE.InterpolateDiscrete;
    for (const key of track.keys) key.time -= 0.001;  // of a step: three.js rounds times, and a beam must not come late
  }
}
