/** Points per workgroup, and threads that share a long row. */
export const WORKGROUP_SIZE = 64;

/**
 * One pass of a splitting method over all points (splittingStages.ts), in 32-bit floats. Positions and momenta are
 * stored as origins and changes since: the increments of each pass are small, and so is their rounding error. Bindings
 * and layouts: integratorPasses.ts and bufferLayout.ts.
 */
export const SPLITTING_WGSL = /* wgsl */ `
struct World {
  // Unit direction of the magnetic field, and its strength [T].
  field: vec3f, strength: f32,
  // 1/c² [s²/m²]; number of points and of short rows; whether there are contacts between nearby points.
  perSquare: f32, points: u32, short: u32, touching: u32,
  // Contact stiffness [N/m] and distance [m]; maximum travel of a point, squared [m²].
  touchStrength: f32, touchReach: f32, touchWay: f32,
}
struct Stage { kick: f32, drift: f32, damp: f32, after: f32, before: f32 }
// Constant force [N], mass [kg], charge [C]; start of the row's springs, start of its other links, end of the row; whether it is pinned.
struct Body { pull: vec3f, mass: f32, charge: f32, springs: u32, others: u32, end: u32, held: u32 }
// Position [m] and momentum [kg m/s] at the start of the batch.
struct Origin { place: vec3f, momentum: vec3f }
// Changes since.
struct Change { way: vec3f, impulse: vec3f }
struct Link { other: u32, law: u32, strength: f32, length: f32 }
// A plane's normal is z in its own frame. 'rest': rounding error of 'middle'. 'turn': rotation from its frame to the world. 'half': half sizes of a box; negative for a plane.
struct Obstacle { middle: vec3f, rest: vec3f, turn: vec4f, half: vec3f }

@group(0) @binding(0) var<uniform> world: World;
@group(0) @binding(1) var<uniform> stage: Stage;
@group(0) @binding(2) var<storage, read> bodies: array<Body>;
@group(0) @binding(3) var<storage, read> origins: array<Origin>;
@group(0) @binding(4) var<storage, read> links: array<Link>;
@group(0) @binding(5) var<storage, read> obstacles: array<Obstacle>;
@group(0) @binding(6) var<storage, read> near: array<u32>;
@group(0) @binding(7) var<storage, read> here: array<Change>;
@group(0) @binding(8) var<storage, read_write> next: array<Change>;
// Lowest index of a point that passed through a solid, and whether a point travelled beyond the validity of the neighbour list.
@group(0) @binding(9) var<storage, read_write> marks: array<atomic<u32>, 2>;

fn momentum(i: u32) -> vec3f { return origins[i].momentum + here[i].impulse; }

// v = p/√(m² + p²/c²)
fn velocity(p: vec3f, mass: f32) -> vec3f {
  let u = p / mass;
  return u / sqrt(1.0 + dot(u, u) * world.perSquare);
}

// x_i − x_j
fn apart(i: u32, j: u32) -> vec3f {
  return (origins[i].place - origins[j].place) + (here[i].way - here[j].way);
}

fn mark(i: u32) { atomicMin(&marks[0], i); }

// −k(r − L) of a spring along the line between its ends; a penalty only repels.
fn spring(d: vec3f, strength: f32, length0: f32, pushes: bool) -> vec3f {
  let r = length(d);
  if (r == 0.0 || (pushes && r >= length0)) { return vec3f(0.0); }
  return (-strength * (r - length0) / r) * d;
}

// Marks pairs nearer than half their contact distance, or that passed each other since the previous pass.
fn refusePierced(i: u32, j: u32, d: vec3f, touch: f32) {
  let v = velocity(momentum(i), bodies[i].mass) - velocity(momentum(j), bodies[j].mass);
  let way = stage.before * v;
  let old = d - way;
  let passed = dot(old, d) < 0.0 && length(old - way * (dot(old, way) / dot(way, way))) < touch;
  if (passed || dot(d, d) < 0.25 * touch * touch) { mark(i); }
}

fn rotate(q: vec4f, v: vec3f) -> vec3f {
  let t = 2.0 * cross(q.xyz, v);
  return v + q.w * t + cross(q.xyz, t);
}

// Signed distance and outward normal, in the obstacle's frame.
fn outOf(half: vec3f, at: vec3f) -> vec4f {
  if (half.x < 0.0) { return vec4f(0.0, 0.0, 1.0, at.z); }
  let over = abs(at) - half;
  let beyond = max(over, vec3f(0.0)) * sign(at);
  let far = length(beyond);
  if (far > 0.0) { return vec4f(beyond / far, far); }
  let side = select(vec3f(-1.0), vec3f(1.0), at >= vec3f(0.0));
  if (over.x >= over.y && over.x >= over.z) { return vec4f(side.x, 0.0, 0.0, over.x); }
  if (over.y >= over.z) { return vec4f(0.0, side.y, 0.0, over.y); }
  return vec4f(0.0, 0.0, side.z, over.z);
}

// Whether a straight path passes through a box.
fn leadsThrough(half: vec3f, from0: vec3f, to: vec3f) -> bool {
  let way = to - from0;
  var enter = 0.0;
  var leave = 1.0;
  for (var k = 0u; k < 3u; k++) {
    if (way[k] == 0.0) {
      if (abs(from0[k]) >= half[k]) { return false; }
      continue;
    }
    let a = (-half[k] - from0[k]) / way[k];
    let b = (half[k] - from0[k]) / way[k];
    enter = max(enter, min(a, b));
    leave = min(leave, max(a, b));
  }
  return enter < leave;
}

fn barrier(i: u32, which: u32, strength: f32, margin: f32) -> vec3f {
  let obstacle = obstacles[which];
  let back = vec4f(-obstacle.turn.xyz, obstacle.turn.w);
  let at = rotate(back, (origins[i].place - obstacle.middle) + (here[i].way - obstacle.rest));
  let out = outOf(obstacle.half, at);
  if (obstacle.half.x >= 0.0) {
    let old = at - rotate(back, stage.before * velocity(momentum(i), bodies[i].mass));
    if (dot(outOf(obstacle.half, old).xyz, out.xyz) < 0.0 && leadsThrough(obstacle.half, old, at)) { mark(i); }
  }
  return rotate(obstacle.turn, (strength * max(0.0, margin - out.w)) * out.xyz);
}

fn sprung(i: u32, link: Link) -> vec3f { return spring(apart(i, link.other), link.strength, link.length, false); }

fn linked(i: u32, link: Link) -> vec3f {
  if (link.law == 3u) { return barrier(i, link.other, link.strength, link.length); }
  let d = apart(i, link.other);
  if (link.law == 2u) {
    let r = length(d);
    return (link.strength / (r * r * r)) * d;
  }
  refusePierced(i, link.other, d, link.length);
  return spring(d, link.strength, link.length, true);
}

fn touched(i: u32) -> vec3f {
  var force = vec3f(0.0);
  if (world.touching == 0u) { return force; }
  let first = world.points + 1u;
  for (var k = near[i]; k < near[i + 1u]; k++) {
    let j = near[first + k];
    let d = apart(i, j);
    refusePierced(i, j, d, world.touchReach);
    force += spring(d, world.touchStrength, world.touchReach, true);
  }
  return force;
}

// sin and cos to 32 bits: WGSL only guarantees 2⁻¹¹. Reduction to the nearest multiple of π/2, then polynomials (Moshier, Cephes, sinf.c).
fn sinCos(angle: f32) -> vec2f {
  let quarters = round(angle * 0.63661977);
  let x = ((angle - quarters * 1.5703125) - quarters * 4.837512969970703e-4) - quarters * 7.54978995489188e-8;
  let z = x * x;
  let s = x + x * z * ((-1.9515295891e-4 * z + 8.3321608736e-3) * z - 1.6666654611e-1);
  let c = 1.0 - 0.5 * z + z * z * ((2.443315711809948e-5 * z - 1.388731625493765e-3) * z + 4.166664568298827e-2);
  switch (i32(quarters) & 3) {
    case 1: { return vec2f(c, -s); }
    case 2: { return vec2f(-s, -c); }
    case 3: { return vec2f(-c, s); }
    default: { return vec2f(s, c); }
  }
}

// dp/dt = q p × B/γm rotates p about −B by q|B|h/γm.
fn turned(p: vec3f, body: Body, h: f32) -> vec3f {
  let u = p / body.mass;
  let angle = -body.charge * world.strength * h / (body.mass * sqrt(1.0 + dot(u, u) * world.perSquare));
  let b = world.field;
  let half = sinCos(0.5 * angle);
  return 2.0 * half.x * (half.y * cross(b, p) - half.x * (p - dot(p, b) * b));
}

fn advance(i: u32, force: vec3f) {
  let body = bodies[i];
  if (body.held != 0u) {
    next[i] = here[i];
    return;
  }
  let start = origins[i].momentum;
  var impulse = here[i].impulse;
  if (body.charge != 0.0 && world.strength != 0.0) {
    impulse += (0.5 * stage.kick) * force;
    impulse += turned(start + impulse, body, stage.kick);
    impulse += (0.5 * stage.kick) * force;
  } else {
    impulse += stage.kick * force;
  }
  var way = here[i].way;
  if (stage.damp == 0.0) {
    way += (stage.drift + stage.after) * velocity(start + impulse, body.mass);
  } else {
    way += stage.drift * velocity(start + impulse, body.mass);
    impulse -= stage.damp * (start + impulse);
    way += stage.after * velocity(start + impulse, body.mass);
  }
  if (world.touching != 0u && !(dot(way, way) <= world.touchWay)) { atomicStore(&marks[1], 1u); }
  next[i] = Change(way, impulse);
}

@compute @workgroup_size(${WORKGROUP_SIZE})
fn shortRows(@builtin(global_invocation_id) id: vec3u) {
  let i = id.x;
  if (i >= world.short) { return; }
  var force = vec3f(0.0);
  let body = bodies[i];
  if (stage.before != 0.0 && body.held == 0u) {
    for (var k = body.springs; k < body.others; k++) { force += sprung(i, links[k]); }
    for (var k = body.others; k < body.end; k++) { force += linked(i, links[k]); }
    force += body.pull + touched(i);
  }
  advance(i, force);
}

var<workgroup> sums: array<vec3f, ${WORKGROUP_SIZE}>;

@compute @workgroup_size(${WORKGROUP_SIZE})
fn longRows(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) thread: u32) {
  let i = world.short + group.x;
  let body = bodies[i];
  var force = vec3f(0.0);
  if (stage.before != 0.0) {
    for (var k = body.springs + thread; k < body.others; k += ${WORKGROUP_SIZE}u) { force += sprung(i, links[k]); }
    for (var k = body.others + thread; k < body.end; k += ${WORKGROUP_SIZE}u) { force += linked(i, links[k]); }
  }
  sums[thread] = force;
  workgroupBarrier();
  for (var half = ${WORKGROUP_SIZE / 2}u; half > 0u; half /= 2u) {
    if (thread < half) { sums[thread] += sums[thread + half]; }
    workgroupBarrier();
  }
  if (thread == 0u) {
    if (stage.before != 0.0) { force = sums[0] + body.pull + touched(i); }
    advance(i, force);
  }
}
`;
