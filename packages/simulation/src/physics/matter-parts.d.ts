/**
 * Types for the three matter-js modules that the simulation imports by file. The whole library,
 * with its renderer, constraints and mouse input, would make up two thirds of the worker's size.
 */
declare module "matter-js/src/body/Body.js" {
  import type Matter from "matter-js";
  const Body: typeof Matter.Body;
  export default Body;
}

declare module "matter-js/src/geometry/Bounds.js" {
  import type Matter from "matter-js";
  const Bounds: typeof Matter.Bounds;
  export default Bounds;
}

declare module "matter-js/src/collision/Collision.js" {
  import type Matter from "matter-js";
  const Collision: typeof Matter.Collision;
  export default Collision;
}
