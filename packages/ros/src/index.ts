export { closeReasonFor } from "./close-reason.ts";
export { keyInAuth } from "./operations.ts";
export { RosError } from "./ros-error.ts";
export { RosSession, type RosSessionOptions } from "./ros-session.ts";
