/** Why a request of a ROS client is refused, as a sentence for `/rosout` or its reply. */
export class RosError extends Error {
  override readonly name = "RosError";
}
