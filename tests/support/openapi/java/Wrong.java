import corridor.model.ForwardOrder;
import corridor.model.ReverseOrder;

class Wrong {
  Object order = new ForwardOrder().action(ReverseOrder.ActionEnum.REVERSE);
}
