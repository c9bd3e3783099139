#include "desktop.h"

#include "child.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <array>
#include <optional>

namespace glint::test {
namespace {

constexpr double time_limit = 10;

/// An invisible window for messages.
class Party {
  public:
    explicit Party(const std::string& display) : display_(XOpenDisplay(display.c_str())) {
        if (display_ != nullptr) window_ = XCreateSimpleWindow(display_, root(), 0, 0, 1, 1, 0, 0, 0);
    }
    ~Party() {
        if (display_ != nullptr) XCloseDisplay(display_);
    }
    Party(const Party&) = delete;
    Party& operator=(const Party&) = delete;

    bool is_there() const { return display_ != nullptr; }
    Display* display() const { return display_; }
    Window window() const { return window_; }
    Window root() const { return DefaultRootWindow(display_); }
    Atom atom(const char* name) const { return XInternAtom(display_, name, 0); }

    /// The next message that `wanted` accepts.
    template <class Wanted>
    std::optional<XEvent> wait(const Wanted& wanted) const {
        for (const double end = now() + time_limit; now() < end; sleep_for(0.005))
            while (XPending(display_) > 0) {
                XEvent event;
                XNextEvent(display_, &event);
                if (wanted(event)) return event;
            }
        return std::nullopt;
    }

    /// A property of a window, as bytes.
    std::string property(Window window, Atom name) const {
        Atom type = 0;
        int bits = 0;
        unsigned long count = 0;
        unsigned long rest = 0;
        unsigned char* data = nullptr;
        XGetWindowProperty(display_, window, name, 0, 65536, 0, AnyPropertyType, &type, &bits, &count, &rest,
                           &data);
        std::string bytes;
        if (data != nullptr && bits == 8) bytes.assign(reinterpret_cast<const char*>(data), count);
        if (data != nullptr && bits == 32) bytes.assign(count, '\1');
        if (data != nullptr) XFree(data);
        return bytes;
    }

  private:
    Display* display_;
    Window window_ = 0;
};

/// The window that accepts drops.
Window taker(const Party& party) {
    Window root = 0;
    Window parent = 0;
    Window* children = nullptr;
    unsigned count = 0;
    XQueryTree(party.display(), party.root(), &root, &parent, &children, &count);
    Window found = 0;
    for (unsigned i = 0; i < count; ++i)
        if (!party.property(children[i], party.atom("XdndAware")).empty()) found = children[i];
    if (children != nullptr) XFree(children);
    return found;
}

void say(const Party& party, Window to, const char* what, const std::array<long, 4>& more) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = to;
    event.xclient.message_type = party.atom(what);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(party.window());
    for (std::size_t i = 0; i < more.size(); ++i) event.xclient.data.l[i + 1] = more[i];
    XSendEvent(party.display(), to, 0, NoEventMask, &event);
    XFlush(party.display());
}

/// Answers requests for the selection.
void hand_over(const Party& party, const XSelectionRequestEvent& request, const std::string& text) {
    XChangeProperty(party.display(), request.requestor, request.property, request.target, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
    XEvent answer{};
    answer.xselection.type = SelectionNotify;
    answer.xselection.requestor = request.requestor;
    answer.xselection.selection = request.selection;
    answer.xselection.target = request.target;
    answer.xselection.property = request.property;
    answer.xselection.time = request.time;
    XSendEvent(party.display(), request.requestor, 0, NoEventMask, &answer);
    XFlush(party.display());
}

} // namespace

bool drop_file(const std::string& display, const std::string& path) {
    const Party party(display);
    if (!party.is_there()) return false;
    const Window to = taker(party);
    if (to == 0) return false;
    const auto is = [&](const char* what) {
        return [name = party.atom(what)](const XEvent& event) {
            return event.type == ClientMessage && event.xclient.message_type == name;
        };
    };
    XSetSelectionOwner(party.display(), party.atom("XdndSelection"), party.window(), CurrentTime);
    constexpr long version = 5L << 24;
    say(party, to, "XdndEnter", {version, static_cast<long>(party.atom("text/uri-list")), 0, 0});
    constexpr long position = 100L << 16 | 100;
    say(party, to, "XdndPosition",
        {0, position, CurrentTime, static_cast<long>(party.atom("XdndActionCopy"))});
    if (!party.wait(is("XdndStatus"))) return false;
    say(party, to, "XdndDrop", {0, CurrentTime, 0, 0});
    const auto asked = party.wait([](const XEvent& event) { return event.type == SelectionRequest; });
    if (!asked) return false;
    hand_over(party, asked->xselectionrequest, "file://" + path + "\r\n");
    return party.wait(is("XdndFinished")).has_value();
}

std::string clipboard(const std::string& display) {
    const Party party(display);
    if (!party.is_there()) return {};
    const Atom answer = party.atom("GLINT_TEST");
    XConvertSelection(party.display(), party.atom("CLIPBOARD"), party.atom("UTF8_STRING"), answer,
                      party.window(), CurrentTime);
    const auto got = party.wait([](const XEvent& event) { return event.type == SelectionNotify; });
    if (!got || got->xselection.property == 0) return {};
    return party.property(party.window(), answer);
}

} // namespace glint::test
