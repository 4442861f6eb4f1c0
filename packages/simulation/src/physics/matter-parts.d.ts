/**
 * The three parts of matter-js that the simulation uses, by their own files: the whole library, with its
 * renderer, constraints and mouse, would be two thirds of the worker.
 */
declare module "matter-js/src/body/Body.js" {
  const Body: typeof import("matter-js").Body;
  export default Body;
}

declare module "matter-js/src/geometry/Bounds.js" {
  const Bounds: typeof import("matter-js").Bounds;
  export default Bounds;
}

declare module "matter-js/src/collision/Collision.js" {
  const Collision: typeof import("matter-js").Collision;
  export default Collision;
}
