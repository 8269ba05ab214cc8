#include "base/diagnostics.h"
#include "language/function_code.h"

#include <fmt/format.h>

namespace rb {

namespace {

class MissingFunction final : public Function {
public:
    explicit MissingFunction(int number) : number_(number) {}
    int parameter_count() const override { return 4; }
    int result_count() const override { return 1; }
    void evaluate(std::span<const double>, std::span<double>) const override {
        throw SceneError({}, fmt::format("internal({}) is not supported yet.", number_));
    }

private:
    int number_;
};

}  // namespace

FunctionPtr internal_function(int number) {
    if (number < 0 || number > 78) return nullptr;
    return std::make_shared<MissingFunction>(number);
}

}  // namespace rb
